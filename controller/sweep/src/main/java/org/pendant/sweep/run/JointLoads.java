package org.pendant.sweep.run;

import org.pendant.models.arm.Joints;

/**
 * Joint loads: what the joints of an arm took of a run, by the base first.
 *
 * @param peak the largest magnitudes
 * @param rms root of the mean square over all frames
 * @param share the largest magnitudes as a share of what each joint can do; NaN where no limit is
 *     known
 */
public record JointLoads(Joints peak, Joints rms, Joints share) {}
