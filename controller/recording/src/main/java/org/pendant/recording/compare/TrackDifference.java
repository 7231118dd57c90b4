package org.pendant.recording.compare;

import java.util.Optional;

/**
 * Track difference: where a run first does something else than an earlier one.
 *
 * @param frame in which it does
 * @param line that its program was at then, from 1; 0 where none ran
 * @param words what, when, both values and the tolerance, for people
 * @param curves of both runs around it; empty where what differs has no curve, as text has none
 */
public record TrackDifference(long frame, int line, String words, Optional<TrackCurves> curves) {}
