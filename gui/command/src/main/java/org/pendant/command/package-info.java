/**
 * Command line of {@code pendant}: subcommands, their options, output streams and exit codes. Open
 * {@link org.pendant.command.Pendant} first; {@link org.pendant.command.RunCommand} is the one that
 * CI calls.
 */
package org.pendant.command;
