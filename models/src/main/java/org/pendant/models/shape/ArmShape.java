package org.pendant.models.shape;

import org.pendant.models.arm.Confidence;

/**
 * The outside of one arm model: a base and six moving bodies made of cylinders.
 *
 * <p>Each body is described in the frame at its near end: the origin on the axis of the joint that
 * moves it, z along that axis. With {@code Rz(q_i)} the turn by the position of joint i, these are
 *
 * <ul>
 *   <li>base: the base frame;
 *   <li>shoulder: {@code Rz(q_1) Tz(d1)} after the base frame;
 *   <li>upper arm: {@code Rz(q_2)} after Denavit-Hartenberg frame 1; the body lies along negative x
 *   <li>forearm: {@code Rz(q_3)} after frame 2; the body lies along negative x
 *   <li>wrist 1: {@code Rz(q_4) Tz(d4)} after frame 3, wrist 2: {@code Rz(q_5) Tz(d5)} after frame
 *       4, wrist 3: {@code Rz(q_6) Tz(d6)} after frame 5, with the face of the flange at z = 0.
 * </ul>
 *
 * @param id the model, as in {@link org.pendant.models.arm.ArmLibrary}
 * @param status whether the numbers were measured on this model
 * @param base the fixed foot
 * @param shoulder moved by joint 1
 * @param upperArm moved by joint 2
 * @param forearm moved by joint 3
 * @param wrist1 moved by joint 4
 * @param wrist2 moved by joint 5
 * @param wrist3 moved by joint 6
 */
public record ArmShape(
    String id,
    Confidence status,
    Base base,
    JointHousing shoulder,
    Limb upperArm,
    Limb forearm,
    JointHousing wrist1,
    JointHousing wrist2,
    JointHousing wrist3) {}
