/**
 * Services that the desktop provides to the command line, and what both know of a start and of
 * tests: the {@code pendant} command finds them with {@link java.util.ServiceLoader}, and says so
 * where there is no desktop on the class path. Open {@link
 * org.pendant.command.service.DesktopLauncher} first.
 */
package org.pendant.command.service;
