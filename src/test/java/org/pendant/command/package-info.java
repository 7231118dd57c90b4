/**
 * The {@code pendant} command as a user meets it: every test starts the launcher as a process and
 * looks at its streams and exit code. Open {@link org.pendant.command.Launcher} first.
 */
package org.pendant.command;
