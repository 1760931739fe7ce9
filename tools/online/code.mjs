// The editor's own part: CodeMirror with C++, in the site's colours. Its lines are numbered as in the whole file.
import { closeBrackets, closeBracketsKeymap } from '@codemirror/autocomplete';
import { defaultKeymap, history, historyKeymap, indentWithTab } from '@codemirror/commands';
import { cppLanguage } from '@codemirror/lang-cpp';
import { bracketMatching, flatIndent, HighlightStyle, indentNodeProp, indentOnInput, indentUnit, syntaxHighlighting } from '@codemirror/language';
import { Annotation, Compartment, EditorSelection, EditorState, Prec, StateEffect, StateField } from '@codemirror/state';
import { Decoration, EditorView, highlightActiveLine, keymap, lineNumbers } from '@codemirror/view';
import { tags } from '@lezer/highlight';

// Nothing is indented for being in a namespace.
const cpp = cppLanguage.configure({ props: [indentNodeProp.add({ DeclarationList: flatIndent })] });

const colours = HighlightStyle.define([
  { tag: [tags.keyword, tags.controlKeyword, tags.modifier, tags.definitionKeyword, tags.self, tags.null, tags.bool], color: 'var(--keyword)' },
  { tag: [tags.typeName, tags.standard(tags.typeName)], color: 'var(--type)' },
  { tag: tags.comment, color: 'var(--comment)' },
  { tag: [tags.string, tags.character, tags.special(tags.string)], color: 'var(--string)' },
  { tag: [tags.processingInstruction, tags.macroName], color: 'var(--macro)' },
]);

// What didn't come from this editor, and is not for it to say further.
const fromOutside = Annotation.define();

const numbered = (linesBefore) => lineNumbers({ formatNumber: (line) => String(line + linesBefore) });

// The line that doesn't compile is marked until it's changed.
const broken = Decoration.line({ class: 'broken', attributes: { role: 'group', 'aria-label': 'This line doesn’t compile' } });
const breaks = StateEffect.define(); // decorations
const brokenLine = StateField.define({
  create: () => Decoration.none,
  update(marks, { startState: { doc }, changes, effects }) {
    const left = marks.update({ filter: (from) => !changes.touchesRange(from, doc.lineAt(from).to) }).map(changes);
    return effects.find((effect) => effect.is(breaks))?.value ?? left;
  },
  provide: (field) => EditorView.decorations.from(field),
});

export class Code {
  // `typed(text)` when the reader changed it, `check()` for Ctrl+Enter, `label` for those who don't see it.
  constructor(parent, { label, describedBy, typed, check }) {
    const run = () => (check(), true);
    this.numbers = new Compartment();
    this.extensions = [
      this.numbers.of(numbered(0)),
      history(),
      cpp,
      indentUnit.of('    '),
      indentOnInput(),
      bracketMatching(),
      closeBrackets(),
      syntaxHighlighting(colours),
      highlightActiveLine(),
      brokenLine,
      matchMedia('(max-width: 32rem)').matches ? EditorView.lineWrapping : [],
      Prec.highest(keymap.of([{ key: 'Ctrl-Enter', run }, { key: 'Mod-Enter', run }])),
      keymap.of([...closeBracketsKeymap, ...defaultKeymap, ...historyKeymap, indentWithTab]),
      EditorView.contentAttributes.of({ 'aria-label': label, 'aria-describedby': describedBy, tabindex: '0' }),
      EditorView.updateListener.of(({ docChanged, state, transactions }) => {
        if (docChanged && !transactions.some((one) => one.annotation(fromOutside))) typed(state.doc.toString());
      }),
    ];
    this.view = new EditorView({ parent, extensions: this.extensions });
  }

  get text() {
    return this.view.state.doc.toString();
  }

  // Another text: what differs is replaced, so that the cursor stays where it is.
  set(text, linesBefore) {
    const before = this.text;
    let start = 0, end = 0;
    const shorter = Math.min(before.length, text.length);
    while (start < shorter && before[start] === text[start]) ++start;
    while (end < shorter - start && before.at(-1 - end) === text.at(-1 - end)) ++end;
    const changes = before === text ? [] : { from: start, to: before.length - end, insert: text.slice(start, text.length - end) };
    const effects = linesBefore === this.linesBefore ? [] : this.numbers.reconfigure(numbered(linesBefore));
    this.linesBefore = linesBefore;
    this.view.dispatch({ changes, effects, annotations: fromOutside.of(true) });
  }

  // Another part of the file, with a history of its own.
  begin(text, linesBefore) {
    this.linesBefore = linesBefore;
    this.view.setState(EditorState.create({ doc: text, extensions: this.extensions }));
    this.view.dispatch({ effects: this.numbers.reconfigure(numbered(linesBefore)) });
  }

  // Marks a line of this editor's, counted from 1, as the one that doesn't compile; none where there's no such line.
  markBroken(line) {
    const { doc } = this.view.state;
    this.view.dispatch({ effects: breaks.of(line >= 1 && line <= doc.lines ? Decoration.set(broken.range(doc.line(line).from)) : Decoration.none) });
  }

  // Calls this when the reader enters next: at the focus, and once more after a press that brought it, since that puts the cursor
  // somewhere.
  whenEntered(act) {
    const { contentDOM } = this.view, typing = new AbortController(), once = { once: true, signal: typing.signal };
    for (const kind of ['focus', 'click']) contentDOM.addEventListener(kind, act, once);
    contentDOM.addEventListener('keydown', () => typing.abort(), once);
  }
  // Selects what's to be replaced, unless the reader selected something.
  offer(from, to) {
    if (this.view.state.selection.main.empty) this.view.dispatch({ selection: EditorSelection.range(to, from) });
  }

  // Puts the cursor there; line and column count from 1 in this editor's text.
  go(line, column) {
    const { doc } = this.view.state, at = doc.line(Math.min(Math.max(line, 1), doc.lines));
    const head = Math.min(at.from + column - 1, at.to);
    this.view.dispatch({ selection: EditorSelection.cursor(head), effects: EditorView.scrollIntoView(head, { y: 'center' }) });
    this.view.focus();
  }
  focus() {
    this.view.focus();
  }
}
