# Rscript analyse.R RUNS.csv TERMS: fits y on the terms of the factors in RUNS.csv and prints what R itself
# has to say about the model, one "key value" a line with 17 digits. TERMS in R's notation: A B A:B I(A^2).
arguments <- commandArgs(trailingOnly = TRUE)
runs <- read.csv(arguments[1])
words <- arguments[-1]
keep_order <- function(words) terms(reformulate(words, "y"), keep.order = TRUE)
model <- lm(keep_order(words), runs)

say <- function(key, value) cat(sprintf("%s %.17g\n", gsub(" ", "", key), value), sep = "")
each <- function(what, names, values) say(paste(what, names, sep = "/"), values)

s <- summary(model)
names <- rownames(s$coefficients)
each("value", names, s$coefficients[, 1])
each("standard_error", names, s$coefficients[, 2])
each("t", names, s$coefficients[, 3])
each("p", names, s$coefficients[, 4])
interval <- confint(model)
each("lower", names, interval[, 1])
each("upper", names, interval[, 2])
say("residual_sd", s$sigma)
say("r_squared", s$r.squared)
say("adjusted_r_squared", s$adj.r.squared)
say("press", sum((residuals(model) / (1 - hatvalues(model)))^2))
say("model/f", s$fstatistic[[1]])
say("model/p", pf(s$fstatistic[[1]], s$fstatistic[[2]], s$fstatistic[[3]], lower.tail = FALSE))

dropped <- drop1(model, . ~ ., test = "F")[-1, ]
each("adjusted_ss", rownames(dropped), dropped[["Sum of Sq"]])
each("f", rownames(dropped), dropped[["F value"]])
each("p_of_f", rownames(dropped), dropped[["Pr(>F)"]])
added <- anova(model)
each("sequential_ss", rownames(added), added[["Sum Sq"]])

# R's anova says NA where F is below the machine's precision: whether a rounding of zero is, hangs on the processor.
of_zero <- function(value, at_zero) ifelse(is.na(value), at_zero, value)

# A group of terms together: the full model against the one without them.
group <- function(name, is_in) {
  if (!any(is_in)) return(invisible())
  rest <- words[!is_in]
  reduced <- if (length(rest)) lm(keep_order(rest), runs) else lm(y ~ 1, runs)
  comparison <- anova(reduced, model)
  say(paste0("group_ss/", name), comparison[["Sum of Sq"]][2])
  say(paste0("group_f/", name), of_zero(comparison[["F"]][2], 0))
  say(paste0("group_p/", name), of_zero(comparison[["Pr(>F)"]][2], 1))
}
is_square <- grepl("I\\(", words)
is_interaction <- grepl(":", words)
group("square", is_square)
group("interaction", is_interaction)
group("linear", !is_square & !is_interaction)
factors <- setdiff(colnames(runs), "y")
holds <- function(word, one) one %in% all.vars(str2lang(word))
for (one in factors) group(one, sapply(words, holds, one))

# Lack of fit: the model against a mean of its own at each point.
point <- do.call(paste, runs[factors])
if (anyDuplicated(point)) {
  comparison <- anova(model, lm(y ~ factor(point), cbind(runs, point = point)))
  say("pure_error_ss", comparison[["RSS"]][2])
  say("lack_ss", comparison[["Sum of Sq"]][2])
  say("lack_f", comparison[["F"]][2])
  say("lack_p", comparison[["Pr(>F)"]][2])
}

place <- as.data.frame(as.list(setNames(seq(0.2, by = 0.3, length.out = length(factors)), factors)))
for (kind in c("confidence", "prediction")) {
  said <- predict(model, place, interval = kind)
  each(kind, c("value", "lower", "upper"), said[1, ])
}
