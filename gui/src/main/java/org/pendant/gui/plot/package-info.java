/**
 * The screen of charts over robot time. Open {@link org.pendant.gui.plot.PlotPresenter} first;
 * {@link org.pendant.gui.plot.Quantity} says what can be drawn.
 */
package org.pendant.gui.plot;
