package org.pendant.command.service;

import java.nio.file.Path;
import org.pendant.controller.installation.Installation;

/**
 * Start installation: the one that a desktop begins with.
 *
 * @param file where it was read
 * @param installation what it says
 */
public record StartInstallation(Path file, Installation installation) {}
