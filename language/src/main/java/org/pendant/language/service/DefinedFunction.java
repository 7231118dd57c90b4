package org.pendant.language.service;

import org.pendant.language.signature.Signature;
import org.pendant.language.source.SourceRange;

/**
 * Defined function: a function or thread of a text.
 *
 * @param signature as callers see it, with the comment above it
 * @param nameRange its name in the head
 */
public record DefinedFunction(Signature signature, SourceRange nameRange) {}
