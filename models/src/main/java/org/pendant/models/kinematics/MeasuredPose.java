package org.pendant.models.kinematics;

import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/**
 * Measured pose: where the flange of an arm truly was while its joints were somewhere.
 *
 * @param positionRad what the encoders said, rad
 * @param flangeInBase what an instrument outside said
 */
public record MeasuredPose(Joints positionRad, Pose flangeInBase) {}
