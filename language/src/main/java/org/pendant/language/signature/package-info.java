/**
 * Signatures: the shape of a function declaration, without its code: open {@link
 * org.pendant.language.signature.Signature} first. The language knows no function by name; it is
 * handed a {@link org.pendant.language.signature.Catalogue}.
 */
package org.pendant.language.signature;
