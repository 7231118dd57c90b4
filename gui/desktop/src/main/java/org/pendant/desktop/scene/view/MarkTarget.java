package org.pendant.desktop.scene.view;

import java.awt.geom.Point2D;
import java.util.Optional;

/**
 * Mark target: a place or a way of the program, or a point of the tool's way, that the pointer is
 * on.
 *
 * @param words what is known of it, in lines
 * @param node key of the node that goes there; 0 for a place that no node goes to
 * @param line of the program at which the tool was there; 0 for none
 * @param timeS when the tool was there, robot time, s; NaN for what is not of its way
 * @param at where it is, or where the way ends, pixels
 * @param from where the way begins; empty for a place
 */
record MarkTarget(
    String words, long node, int line, double timeS, Point2D at, Optional<Point2D> from) {}
