package org.pendant.desktop.log;

/**
 * Log place: where in a program a message comes from.
 *
 * @param brief for a narrow column, such as {@code 12} or {@code node 3}
 * @param words within a sentence, such as {@code line 12} or {@code node 3 Point}
 * @param show shows it
 */
public record LogPlace(String brief, String words, Runnable show) {}
