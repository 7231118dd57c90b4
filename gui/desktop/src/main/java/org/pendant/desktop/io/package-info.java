/**
 * I/O screen of signals and readings: see every level, force inputs, name signals. Open {@link
 * org.pendant.desktop.io.IoPresenter} first.
 */
package org.pendant.desktop.io;
