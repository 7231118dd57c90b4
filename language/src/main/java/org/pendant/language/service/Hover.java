package org.pendant.language.service;

import org.pendant.language.source.SourceRange;

/**
 * Hover: what is known about the name under the pointer, as ordinary text (not bytes).
 *
 * @param range the name
 * @param head one line of code, e.g. {@code movej(q, a=1.4, v=1.05, t=0, r=0)}
 * @param text sentences, one a line; may be empty
 */
public record Hover(SourceRange range, String head, String text) {}
