/**
 * Sources: script text and places in it: a {@link org.pendant.language.source.Source} holds the
 * bytes of one file and turns offsets into lines and columns. Open {@link
 * org.pendant.language.source.Diagnostic} next: every complaint about a program is one.
 */
package org.pendant.language.source;
