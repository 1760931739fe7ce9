// 2.2: where the line of momentum cuts the ellipse of energy: one solution is known, and the sum of both is -p / q
#include "momentum.hpp"

namespace momentum {

Velocities elastic_collision(const Cart &a, const Cart &b) {
    for (const Cart *cart : {&a, &b}) {
        course::require(cart->mass > 0, "mass [kg] must be positive", cart->mass);
    }
    if (b.velocity >= a.velocity) return {a.velocity, b.velocity};
    // v_b = (P - m_a v_a) / m_b in m_a v_a² + m_b v_b² = 2 E: (m_a + m_a²/m_b) v_a² - 2 P m_a/m_b v_a + ... = 0
    const double momentum = a.mass * a.velocity + b.mass * b.velocity;
    const double sum_of_a = 2 * momentum / (a.mass + b.mass), sum_of_b = sum_of_a;
    return {sum_of_a - a.velocity, sum_of_b - b.velocity};
}

} // namespace momentum
