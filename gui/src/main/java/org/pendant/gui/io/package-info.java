/**
 * The screen of signals and readings: see every level, force inputs, name signals. Open {@link
 * org.pendant.gui.io.IoPresenter} first.
 */
package org.pendant.gui.io;
