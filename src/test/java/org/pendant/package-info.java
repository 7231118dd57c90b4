/**
 * Tests of Pendant as a whole, through the doors its users have: the command line, scripts, ports.
 * Open {@link org.pendant.ArchitectureTest} first: it says what the modules may know of one
 * another.
 */
package org.pendant;
