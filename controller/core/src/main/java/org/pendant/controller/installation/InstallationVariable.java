package org.pendant.controller.installation;

/**
 * Installation variable: every program has it, and it keeps its value.
 *
 * @param name of the language
 * @param value as a literal of the language, such as {@code [1, 2]} or {@code "text"}
 * @param favourite whether it is shown first
 */
public record InstallationVariable(String name, String value, boolean favourite) {}
