package org.pendant.desktop.plot;

/**
 * Chart trace: a quantity on a chart.
 *
 * @param color number of its colour in the palette; they differ on one chart
 */
record ChartTrace(ChartQuantity quantity, int color) {}
