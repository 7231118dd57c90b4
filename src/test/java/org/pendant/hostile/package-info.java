/**
 * Programs that mean harm: none of them holds up a frame, another thread or a stop. Open {@link
 * org.pendant.hostile.HostileScriptsTest} first; the programs are in {@link
 * org.pendant.hostile.HostilePrograms}.
 */
package org.pendant.hostile;
