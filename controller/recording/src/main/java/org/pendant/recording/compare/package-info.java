/**
 * Comparing a run with a recording of a real arm: tables of samples from whoever wrote them, their
 * alignment in time, and what differs. {@link org.pendant.recording.compare.RunComparison} is the
 * class to open first.
 */
package org.pendant.recording.compare;
