package org.pendant.controller.bench;

import org.pendant.controller.io.Signal;

/**
 * Output follower: a wire of the cell: an input takes the level of an output a while after it has
 * changed, as the switch of a gripper does.
 *
 * @param output what the program sets
 * @param input what follows
 * @param delayFrames 0 or more
 * @param inverted whether the input is high where the output is low
 */
public record OutputFollower(Signal output, Signal input, long delayFrames, boolean inverted) {}
