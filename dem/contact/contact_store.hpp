#pragma once

#include "dem/contact/contact_engine.hpp"
#include "dem/contact/contact_lists.hpp"
#include "dem/contact/multi_contact.hpp"
#include "dem/step/kick.hpp"

namespace dem {

/// What the engine keeps, behind the number type that the case chose.
class ContactEngine::Store {
public:
  virtual ~Store() = default;
  virtual std::unique_ptr<Store> clone() const = 0;
  virtual double kick_and_drift(World& world, double dt) = 0;
  virtual void refresh(World& world, double dt) = 0;
  virtual void sweep(World& world, double dt) = 0;
  virtual void complete(World& world) = 0;
  virtual void evaluate(World& world) = 0;
  virtual void follow_tools(World const& world) = 0;
  virtual std::vector<WallImpulse> take_impulses() = 0;
  virtual void forget(std::span<std::uint32_t const> rows) = 0;
  virtual void visit(World const& world, ContactStream::Visit const& visit) const = 0;
  virtual StoredEnergy energy(World const& world) const = 0;
  virtual double stable_step(World const& world) const = 0;
  virtual ListStatistics statistics(World const& world) const = 0;
  virtual ContactState capture() const = 0;
  virtual void restore(World& world, ContactState const& state) = 0;
};

/// @throws InvalidInput for unknown laws
std::unique_ptr<ContactEngine::Store> make_store(ContactChoice const& choice);

template <class T> class TypedStore final : public ContactEngine::Store {
public:
  explicit TypedStore(ContactChoice const& choice)
      : choice_(choice), kernel_(make_kernel<T>(choice)) {}

  std::unique_ptr<Store> clone() const override { return std::make_unique<TypedStore>(*this); }
  double kick_and_drift(World& world, double dt) override;
  void refresh(World& world, double dt) override;
  void sweep(World& world, double dt) override;
  void complete(World& world) override;
  void evaluate(World& world) override;
  void follow_tools(World const& world) override;
  std::vector<WallImpulse> take_impulses() override;
  void forget(std::span<std::uint32_t const> rows) override;
  void visit(World const& world, ContactStream::Visit const& visit) const override;
  StoredEnergy energy(World const& world) const override;
  double stable_step(World const& world) const override;
  ListStatistics statistics(World const& world) const override;
  ContactState capture() const override;
  void restore(World& world, ContactState const& state) override;

private:
  double reach(World const& world) const;
  bool tools_hold(World const& world) const;
  bool grains_hold(World const& world) const;
  bool chunk_holds(Spheres const& grains, std::size_t chunk) const;
  void start_travel();
  bool try_inner_build(World const& world, double dt);
  void full_build(World& world, double dt);
  void write_records(World const& world);
  void keep_impulses();
  GrainLoad load_of(World const& world, std::uint32_t i) const;
  void tally_tools(World& world, double dt) const;
  template <class Visit>
  void for_each_contact(World const& world, PairTable const& table,
                        CrowdingField<double> const& crowding, ContactBlock<T> const& block,
                        Visit&& visit) const;
  template <class Result, class Visit>
  std::vector<Result> per_block(World const& world, CrowdingField<double> const& crowding,
                                std::size_t first, std::size_t end, Visit&& visit) const;
  CrowdingField<double> crowding_now(World const& world) const;

  ContactChoice choice_;
  ContactKernel<T> kernel_;
  ContactLists<T> lists_;
  std::vector<WallImpulse> impulses_; ///< of this window, of contacts of lists that are gone
  std::vector<MotionRecord<T>> motions_;
  CrowdingField<T> crowding_; ///< of the last sweep
  bool is_open_ = false;      ///< the grains still lack the loads and half kick of the last sweep
  double open_step_ = 0.0;    ///< [s], of that sweep
  bool grains_hold_ = false;  ///< no grain has left its inner skin since the last drift
  std::vector<double>
      travel_; ///< [m], bound on how far any grain of a chunk has moved since the last build
  std::vector<double> least_skin_; ///< [m], of each chunk
  double build_seconds_ = 0.0;
};

} // namespace dem
