/**
 * Commands: what clients ask of a controller and what they are answered. Open {@link
 * org.pendant.controller.command.Command} first; the families of commands are beside their owners.
 */
package org.pendant.controller.command;
