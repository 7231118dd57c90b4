package org.pendant.script.vm;

/**
 * Run limits: what a run of a program may take.
 *
 * @param slices computing time of its threads
 * @param memoryBytes all its values together, see {@link org.pendant.script.value.Value#sizeBytes}
 */
record RunLimits(Slices slices, long memoryBytes) {}
