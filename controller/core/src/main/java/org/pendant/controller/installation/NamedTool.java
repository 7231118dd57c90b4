package org.pendant.controller.installation;

import org.pendant.models.pose.Pose;

/**
 * Tool centre point with a name.
 *
 * @param name its own among all TCPs
 * @param inFlange pose in the flange frame, m and rotation vector in rad
 */
public record NamedTool(String name, Pose inFlange) {}
