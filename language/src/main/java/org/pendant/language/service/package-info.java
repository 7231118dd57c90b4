/**
 * Language service: what an editor asks about script text, in terms of offsets and edits, without
 * any user interface: open {@link org.pendant.language.service.ScriptAnalysis} first. Every answer
 * works on half-typed programs, is immutable, and is the same for a desktop editor and for a
 * language server.
 */
package org.pendant.language.service;
