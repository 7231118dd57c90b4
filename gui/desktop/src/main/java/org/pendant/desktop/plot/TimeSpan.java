package org.pendant.desktop.plot;

/**
 * Time span: a stretch of time that the pointer is drawing.
 *
 * @param fromS where it began, s
 * @param toS where the pointer is, s
 */
record TimeSpan(double fromS, double toS) {}
