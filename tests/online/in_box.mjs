// The parts of the editor in the box of an exercise.
export function inBox(page, exercise = '8.1') {
  const box = page.locator(`.turn[data-exercise="${exercise}"]`), button = (name) => box.getByRole('button', { name, exact: true });
  return {
    box, button, code: box.locator('.cm-content'), verdict: box.locator('.verdict'), note: box.locator('.note'), menu: box.locator('summary', { hasText: 'My answers' }),
    // As text, with all its lines.
    text: () => box.locator('.cm-line').allTextContents().then((lines) => lines.join('\n')),
    // Instead of what's there.
    async write(text) {
      await box.locator('.cm-content').click();
      await page.keyboard.press('Control+A');
      await page.keyboard.insertText(text);
    },
    check: async () => {
      await box.locator('.cm-content').press('Control+Enter');
      await box.locator('.verdict:not(:empty)').waitFor();
    },
  };
}
