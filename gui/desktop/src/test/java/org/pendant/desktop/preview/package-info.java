/**
 * Single screens in a window of their own, with a controller that runs a program, to try them by
 * hand. Open {@link org.pendant.desktop.preview.Preview} first.
 */
package org.pendant.desktop.preview;
