/**
 * Lines of a program: what each of them took of a run, and how near it came to the limits. Open
 * {@link org.pendant.recording.lines.LineProfiler} first: it takes every frame and answers a {@link
 * org.pendant.recording.lines.RunProfile} at any time.
 */
package org.pendant.recording.lines;
