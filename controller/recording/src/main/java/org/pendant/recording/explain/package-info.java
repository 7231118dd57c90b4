/**
 * Why the arm moved as it did at a moment of a recording: what its frames say for certain, and what
 * is likely where they do not say it. Open {@link org.pendant.recording.explain.MotionExplanation}
 * first.
 */
package org.pendant.recording.explain;
