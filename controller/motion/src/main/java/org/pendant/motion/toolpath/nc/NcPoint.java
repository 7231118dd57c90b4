package org.pendant.motion.toolpath.nc;

import org.pendant.models.pose.Pose;

/**
 * Toolpath point that is reached in a straight line.
 *
 * @param inPart pose of the tool in the part: the tool turned by B about y and then by C about z;
 *     its z-axis points from the tip into the tool
 * @param feedMPerS the feed rate in force, m/s; 0 where the file has given none yet
 * @param line of the file, from 1
 */
public record NcPoint(Pose inPart, double feedMPerS, int line) {}
