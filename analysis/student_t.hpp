#pragma once

namespace analysis {

/// The number t that |T| stays below with this probability, 0 < p < 1, for T of Student's distribution. To
/// 1e-10. No degree of freedom stands for infinitely many (the normal distribution: errors that are known
/// beforehand).
double student_t_two_sided(double probability, int degrees_of_freedom);

}  // namespace analysis
