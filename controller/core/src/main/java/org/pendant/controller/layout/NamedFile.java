package org.pendant.controller.layout;

import org.pendant.models.json.FilePosition;

/**
 * File that a scene names.
 *
 * @param name as it stands there: in the folder of the scene or below, {@code /} between folders
 * @param place where it is named, for messages
 */
public record NamedFile(String name, FilePosition place) {}
