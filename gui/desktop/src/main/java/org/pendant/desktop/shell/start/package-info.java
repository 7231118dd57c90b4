/**
 * Programs that start while the arm is somewhere else than where they go first: what people can do
 * then. Begin at {@code StartChoice}.
 */
package org.pendant.desktop.shell.start;
