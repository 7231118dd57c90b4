/**
 * Reports of sweeps. Open {@link org.pendant.sweep.report.SweepReport} first: it makes one page of
 * a folder of results; its script and style are resources beside it.
 */
package org.pendant.sweep.report;
