/**
 * The desktop as people meet it: a real window on a display of its own, worked with mouse and keys.
 * Open {@link org.pendant.window.OpenWindow} first.
 */
package org.pendant.window;
