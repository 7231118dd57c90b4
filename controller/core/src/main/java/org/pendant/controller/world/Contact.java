package org.pendant.controller.world;

/**
 * Contact: an object that the tool touches.
 *
 * @param object its name
 * @param depthM how deep the tool is pressed in, at the deepest of its points, m
 * @param forceN size of the force between the two, friction included, N
 */
public record Contact(String object, double depthM, double forceN) {}
