/**
 * Program start away from the first waypoint: what people can do when the arm is somewhere else.
 * Begin at {@code StartChoice}.
 */
package org.pendant.desktop.shell.start;
