package org.pendant.controller.world;

/**
 * Link distances: how near the links of an arm are to something, m; below 0 by the depth inside. No
 * number where there is nothing to be near to, or nobody knows.
 *
 * @param nearestM to anything: another link of the arm, an object that stands still, another arm
 * @param objectM to an object that stands still or another arm alone
 */
public record LinkDistances(double nearestM, double objectM) {}
