package org.pendant.protocols.panel;

import org.pendant.controller.machine.Program;

/**
 * A program that waits to be played.
 *
 * @param name of the file without its folder, as clients are told it
 * @param path below {@code /programs/}, as clients are told it
 * @param program compiled
 * @param installation the one that it names; empty if none
 * @param saved whether the file has this very text
 */
public record LoadedProgram(
    String name, String path, Program program, String installation, boolean saved) {}
