package org.pendant.controller.vm;

/**
 * What a run of a program may take.
 *
 * @param slices computing time of its threads
 * @param memoryBytes all its values together, see {@link
 *     org.pendant.controller.value.Value#sizeBytes}
 */
record RunLimits(Slices slices, long memoryBytes) {}
