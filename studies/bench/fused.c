/* The fused chain pass in C, to measure the compiled kernels against: symplectic Euler, one sweep over the
   chain a step, one square root and one division a spring. gcc -O3 -march=native may contract a*b+c. */
#include <math.h>

void fused(long n, long steps, double *x, double *y, double *vx, double *vy, const double *free_mass,
           double k, double c, double rest, double joint_cos, double joint_sin, double gravity, double air,
           double dt)
{
    const double pull = k * rest;
    for (long step = 0; step < steps; step++) {
        double xi = x[0], yi = y[0], ui = vx[0], wi = vy[0];
        double xj = x[1], yj = y[1], uj = vx[1], wj = vy[1];
        double lx = xj - xi, ly = yj - yi, inverse = 1.0 / sqrt(lx * lx + ly * ly);
        double couple_before = 0.0, tx_before = 0.0, ty_before = 0.0;
        for (long i = 0; i < n - 1; i++) {
            double inverse2 = inverse * inverse;
            double rate = lx * (uj - ui) + ly * (wj - wi);
            double along = pull * inverse - k - c * rate * inverse2;
            double couple = 0.0, bx = 0.0, by = 0.0, next = 0.0, xk = 0.0, yk = 0.0, uk = 0.0, wk = 0.0;
            if (i < n - 2) {
                xk = x[i + 2], yk = y[i + 2], uk = vx[i + 2], wk = vy[i + 2];
                bx = xk - xj, by = yk - yj;
                next = 1.0 / sqrt(bx * bx + by * by);
                couple = joint_cos * (lx * by - ly * bx) - joint_sin * (lx * bx + ly * by);
            }
            double across = (couple_before - couple) * inverse2;
            double tx = along * lx + across * ly, ty = along * ly - across * lx;
            double m = free_mass[i] * dt;
            double u = ui + m * (tx_before - tx - air * ui * fabs(ui));
            double w = wi + m * (ty_before - ty - air * wi * fabs(wi) + gravity);
            vx[i] = u, vy[i] = w, x[i] = xi + u * dt, y[i] = yi + w * dt;
            tx_before = tx, ty_before = ty, couple_before = couple;
            xi = xj, yi = yj, ui = uj, wi = wj, xj = xk, yj = yk, uj = uk, wj = wk;
            lx = bx, ly = by, inverse = next;
        }
        double m = free_mass[n - 1] * dt;
        double u = ui + m * (tx_before - air * ui * fabs(ui));
        double w = wi + m * (ty_before - air * wi * fabs(wi) + gravity);
        vx[n - 1] = u, vy[n - 1] = w, x[n - 1] = xi + u * dt, y[n - 1] = yi + w * dt;
    }
}
