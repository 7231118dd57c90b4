package org.pendant.protocols.teachpendant;

import java.util.Optional;
import org.pendant.controller.installation.Installation;
import org.pendant.project.program.file.TreeFile;
import org.pendant.script.vm.Program;

/**
 * Loaded program that waits to be played.
 *
 * @param name of the file without its folder, as clients are told it
 * @param path below {@code /programs/}, as clients are told it
 * @param program compiled; empty where a driver must be asked for a part of it first
 * @param installation the one that it names; empty if none
 * @param setup that installation, if its file is there
 * @param tree that it was generated from; empty for a script
 * @param saved whether the file has this very text
 */
public record LoadedProgram(
    String name,
    String path,
    Optional<Program> program,
    String installation,
    Optional<Installation> setup,
    Optional<TreeFile> tree,
    boolean saved) {}
