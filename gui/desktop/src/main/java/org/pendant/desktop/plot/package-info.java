/**
 * Plot screen of charts over robot time. Open {@link org.pendant.desktop.plot.PlotPresenter} first;
 * {@link org.pendant.desktop.plot.ChartQuantity} says what can be drawn.
 */
package org.pendant.desktop.plot;
