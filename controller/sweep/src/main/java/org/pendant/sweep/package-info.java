/**
 * Sweeps: variants of a program by the thousand. Open {@link org.pendant.sweep.Sweep} first: it
 * reads a plan, runs it into a folder of results and makes the recording of any run.
 */
package org.pendant.sweep;
