/**
 * How the JVM is started for a command line: its options and its cache of classes, one declaration
 * for all launchers. Open {@link org.pendant.command.launch.StartKind} first.
 */
package org.pendant.command.launch;
