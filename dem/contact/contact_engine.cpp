#include "dem/contact/contact_engine.hpp"

#include "dem/contact/contact_store.hpp"
#include "dem/step/world.hpp"

#include <algorithm>
#include <tuple>

namespace dem {

ContactEngine::ContactEngine() : ContactEngine(ContactChoice{}) {}
ContactEngine::ContactEngine(ContactChoice const& choice)
    : choice_(choice), store_(make_store(choice)) {}
ContactEngine::ContactEngine(ContactEngine const& other)
    : choice_(other.choice_), store_(other.store_->clone()) {}
ContactEngine::ContactEngine(ContactEngine&&) noexcept = default;
ContactEngine& ContactEngine::operator=(ContactEngine const& other) {
  if (this != &other)
    *this = ContactEngine(other);
  return *this;
}
ContactEngine& ContactEngine::operator=(ContactEngine&&) noexcept = default;
ContactEngine::~ContactEngine() = default;

double ContactEngine::kick_and_drift(World& world, double dt) {
  return store_->kick_and_drift(world, dt);
}
void ContactEngine::refresh(World& world, double dt) {
  store_->refresh(world, dt);
}
void ContactEngine::sweep(World& world, double dt) {
  store_->sweep(world, dt);
}
void ContactEngine::complete(World& world) {
  store_->complete(world);
}
void ContactEngine::evaluate(World& world) {
  store_->evaluate(world);
}
void ContactEngine::follow_tools(World const& world) {
  store_->follow_tools(world);
}
std::vector<WallImpulse> ContactEngine::take_impulses() {
  return store_->take_impulses();
}
void ContactEngine::forget(std::span<std::uint32_t const> rows) {
  store_->forget(rows);
}
void ContactEngine::visit(World const& world, ContactStream::Visit const& visit) const {
  store_->visit(world, visit);
}
StoredEnergy ContactEngine::energy(World const& world) const {
  return store_->energy(world);
}
double ContactEngine::stable_step(World const& world) const {
  return store_->stable_step(world);
}
ListStatistics ContactEngine::statistics(World const& world) const {
  return store_->statistics(world);
}
ContactState ContactEngine::capture() const {
  return store_->capture();
}
void ContactEngine::restore(World& world, ContactState const& state) {
  store_->restore(world, state);
}

std::unique_ptr<ContactEngine::Store> make_store(ContactChoice const& choice) {
  if (choice.precision == Precision::mixed)
    return std::make_unique<TypedStore<float>>(choice);
  return std::make_unique<TypedStore<double>>(choice);
}

void ContactStream::for_each(Visit const& visit) const {
  if (world_ != nullptr)
    world_->contacts.visit(*world_, visit);
  for (Contact const& contact : contacts_)
    visit(contact);
}

std::vector<Contact> list_contacts(World const& world) {
  std::vector<Contact> contacts;
  world.contacts.visit(world, [&](Contact const& c) { contacts.push_back(c); });
  auto const& id = world.grains.id;
  std::ranges::sort(contacts, {}, [&](Contact const& c) {
    return std::tuple(id[c.i], c.tool == Contact::none ? 0 : 1,
                      c.j == Contact::none ? c.tool : id[c.j], c.patch);
  });
  return contacts;
}

} // namespace dem
