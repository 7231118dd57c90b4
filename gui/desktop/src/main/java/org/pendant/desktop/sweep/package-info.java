/**
 * Sweeps in the window: planned from what the open program offers, run beside the robot, looked at
 * while their table grows. Open {@link org.pendant.desktop.sweep.SweepPresenter} first.
 */
package org.pendant.desktop.sweep;
