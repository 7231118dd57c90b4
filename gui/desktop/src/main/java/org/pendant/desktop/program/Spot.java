package org.pendant.desktop.program;

/**
 * Spot: a place in a tree where nodes can be put.
 *
 * @param parent key of the node above, or {@link org.pendant.project.program.ProgramTree#ROOT}
 * @param index before which of its children; their number for the end
 */
record Spot(long parent, int index) {}
