/**
 * Runs of a sweep: a plan with all that it names, and one variant of it after another in this
 * process. Open {@link org.pendant.sweep.run.SweepJob} first: any thread may have it run any
 * variant.
 */
package org.pendant.sweep.run;
